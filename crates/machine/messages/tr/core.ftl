# Faults common to all controls. What a message is made of and which arguments a detail may name

# stands in src/messages.rs.

with-detail = { $text } ({ $detail })

## Text

FC-0101 = Hiçbir blokta bulunamayacak bir karakter
    .detail = { $character }
    .help = Karakteri silin ya da açıklamanın içine alın.
FC-0102 = Önünde adres olmayan bir sayı
    .detail = { $word }
    .help = Sayının önüne adres harfini koyun ya da sayıyı silin.
FC-0103 = Değeri olmayan bir adres
    .detail = { $word }
    .help = Adres harfinin arkasına değerini yazın ya da harfi silin.
FC-0104 = Olmaması gereken yerde bir işaret
    .detail = { $word }
    .help = Bir sözcükte tek işaret bulunur: adresin hemen arkasında ve yalnız değer eksi olabiliyorsa.
FC-0105 = Olmaması gereken yerde ya da birden çok ondalık nokta
    .detail = { $word }
    .help = En çok bir ondalık nokta yazın; tam sayı olması gereken sözcüklere hiç yazmayın.
FC-0106 = Satır çok uzun
    .detail = en çok { $limit } bayt
    .help = Bloğu birkaç satıra bölün.
FC-0107 = Parantezler eşleşmiyor
    .help = Açılan her parantezi aynı blokta kapatın.
FC-0108 = Parantezler çok derin iç içe
    .detail = en çok { $limit } düzey
    .help = Önce ifadenin bir bölümünü bir değişkende hesaplayın.
FC-0109 = İfade okunamıyor
    .detail = { $word }
    .help = İfadenin işleçlerini, parantezlerini ve değişkenlerini denetleyin.
FC-0110 = Açılan açıklama kapatılmamış
    .help = Açıklamayı aynı satırda kapatın.
FC-0111 = Makro deyimi okunamıyor
    .detail = { $word }
    .help = Deyimin yazımını ve biçimini, kontrolün onu tanıyıp tanımadığını denetleyin.
FC-0112 = Böyle bir fonksiyon yok
    .detail = { $name }
    .help = Yazımını denetleyin; fonksiyonlar kontrolün programlama kılavuzundadır.
FC-0113 = Sayı çok büyük
    .detail = { $word }
    .help = Ondalık noktası unutulmuş ya da bir rakamı iki kez yazılmış mı, bakın.
FC-0114 = Sözcüklerle makro deyimi aynı blokta
    .detail = { $word }
    .help = Makro deyimini ayrı bir bloğa yazın.
FC-0115 = Metin kapatılmamış
    .detail = { $word }
    .help = Metni gereken tırnak ya da parantezle kapatın.

## Words

FC-0201 = Bu kontrolde böyle bir G kodu yok
    .detail = { $word }
    .help = Kodu ve programın bu kontrol için yazılıp yazılmadığını denetleyin.
FC-0202 = Bu kontrolde böyle bir M kodu yok
    .detail = { $word }
    .help = Kodu ve programın bu kontrol için yazılıp yazılmadığını denetleyin.
FC-0203 = Kontrol bu adresi burada kullanmıyor
    .detail = { $word }
    .help = Sözcüğü silin ya da bloğun hangi kodu için yazıldığına bakın.
FC-0204 = Bir adres blokta birden çok kez var
    .detail = { $word }
    .help = Fazla sözcüğü silin ya da bloğu bölün.
FC-0205 = Blokta aynı modal gruptan iki G kodu var
    .detail = { $first } ve { $second }
    .help = Birini silin ya da ayrı bloklara yazın.
FC-0206 = Değer, aralığının dışında
    .detail = { $word }: { $min } ile { $max } arası
    .detail-2 = { $word }
    .help = Adresin alabileceği bir değer programlayın.
FC-0207 = Değer tam sayı olmalı
    .detail = { $word }
    .help = Sözcüğü ondalıksız yazın.
FC-0208 = Değer eksi olamaz
    .detail = { $word }
    .help = İşareti silin ya da değerin çıktığı hesabı denetleyin.
FC-0209 = Kod, blokta tek başına olmalı
    .detail = { $word }
    .help = Kodu ayrı bir bloğa yazın.
FC-0210 = Programı yöneten M kodları aynı blokta
    .detail = { $first } ve { $second }
    .help = M00, M01, M02, M30, M98 ve M99 kodlarının her birini ayrı bir bloğa yazın.
FC-0211 = Blokta çok fazla M kodu var
    .detail = en çok { $limit }
    .help = M kodlarını birkaç bloğa bölün.
FC-0212 = Böyle bir eksen yok
    .detail = { $axis }
    .help = Eksen harfini denetleyin; tezgâhın eksenleri tezgâh dosyasında yazılıdır.

## Motion

FC-0301 = İlerlemesi olmayan kesme hareketi
    .help = Bu blokta ya da öncesinde F programlayın.
FC-0302 = Yayın başı ve sonu merkeze farklı uzaklıkta
    .detail = yarıçap başta { $start }, sonda { $end }; izin verilen fark { $limit }
    .detail-2 = yarıçap başta { $start }, sonda { $end }
    .help = I, J ve K değerlerini, bitiş noktasını ve önceki bloğun bittiği noktayı denetleyin.
FC-0303 = Yayın ne yarıçapı ne merkezi var
    .help = R programlayın ya da merkezi I, J ve K içinden düzlemde olanlarla verin.
FC-0304 = Yay yarıçapı bitiş noktasına ulaşmak için çok küçük
    .detail = R { $radius }, en az { $least } gerekir
    .help = R değerini ve bitiş noktasını denetleyin; R en az baş ile son arasındaki uzaklığın yarısı olmalıdır.
FC-0305 = Yay kendi merkezinde başlıyor
    .help = I, J ve K değerlerini denetleyin: bunlar yayın başından merkezine olan uzaklıklardır.
FC-0306 = Bekleme süresi eksi
    .detail = { $word }
    .help = Bekleme süresini işaretsiz programlayın.
FC-0307 = Helisin dairesi dışında çok fazla eksen var
    .detail = en çok { $limit }
    .help = Yay düzleminin dışında daha az eksen programlayın.
FC-0308 = Bir koordinat, kontrolün alabileceğinin dışında
    .detail = { $axis } { $position }
    .help = Koordinatı, etkin ofsetleri ve ölçek çarpanını denetleyin.
FC-0309 = İlerleme, kontrolün aralığının dışında
    .detail = { $word }
    .help = Sıfırdan büyük ve kontrolün aralığında bir ilerleme programlayın.

## Offsets and coordinate systems

FC-0401 = Böyle bir ofset numarası yok
    .detail = { $number }, en büyüğü { $limit }
    .detail-2 = { $number }
    .help = H ve D numaralarını takım ofset tablosuyla karşılaştırın.
FC-0402 = Böyle bir iş koordinat sistemi yok
    .detail = { $name }
    .help = Kontrolün iş sıfırı tablosundaki sistemlerden birini kullanın.
FC-0403 = Koordinat sistemini kuran blokta boy telafisi var
    .help = Boy telafisini ve G92'yi ayrı bloklara yazın.
FC-0404 = Takım boyu, yay bulunan bir blokta değişiyor
    .detail = { $word }
    .help = Boy telafisini doğrusal hareketli bir blokta değiştirin.

## Canned cycles

FC-0501 = Çevrim bu düzlemde çalışmıyor
    .detail = { $plane }
    .help = Çevrimden önce düzlemini seçin; delme çevrimlerinde G17.
FC-0502 = Delik dibi R düzeyinin altında değil
    .detail = dip { $depth }, R { $r }
    .help = Z ve R değerlerini, mutlak mı artımlı mı olduklarını denetleyin.
FC-0503 = Gagalamalı delme çevriminin dalış adımı yok
    .detail = { $word }
    .help = Sıfırdan büyük bir dalış adımı programlayın; çoğu kontrolde Q.
FC-0504 = Çevrim etkinken düzlem değişiyor
    .help = Düzlem değişmeden önce çevrimi G80 ile bitirin.
FC-0505 = İş mili devri olmayan çevrim
    .help = Çevrimden önce S programlayın ve iş milini çalıştırın.
FC-0506 = Çevrim etkinken referans noktası kodu
    .detail = { $word }
    .help = Bu bloktan önce çevrimi G80 ile bitirin.

## Programs

FC-0601 = Çağrıda program belirtilmemiş
    .help = Çağrılacak programın numarasını ya da adını programlayın.
FC-0602 = Çağrılan program yok
    .detail = { $program }
    .help = Programı program belleğine yükleyin ya da numarasını veya adını denetleyin. M06'da eksik olan takım değiştirme programıdır (O9001 ya da makine dosyasındaki [tool_change] bölümünün belirttiği): iş milinde hâlâ eski takım var.
FC-0603 = Çağrılar çok derin iç içe
    .detail = en çok { $limit } düzey
    .help = Bir programın kendini çağırıp çağırmadığına bakın; çağırmıyorsa alt programların bazılarını birleştirin.
FC-0604 = Çağrının yineleme sayısı çok büyük
    .detail = { $repeats } kez, en çok { $limit }
    .help = Yineleme sayısını denetleyin ya da çağrıyı bir döngüde yineleyin.
FC-0605 = Hiçbir programın numarası bu olamaz
    .detail = { $program }
    .help = Kontrolün izin verdiği bir program numarası kullanın.
FC-0606 = Programın sonu yok
    .help = Ana programı M30 ya da M02, alt programı M99 ile, kontrolde varsa M17 ile bitirin.
FC-0607 = Program % son işaretine geldi
    .help = Programı işaretten önce bitirin: M30 ya da M02 ile, alt programı M99 ile, kontrolde varsa M17 ile.
FC-0608 = Program sonuna gelmiyor
    .help = Döngü ve atlama koşullarını denetleyin.
FC-0609 = Atlanacak sıra numarası yok
    .detail = N{ $number }
    .help = Atlanacak bloğa bu numarayı verin ya da atlamayı düzeltin.

## Variables and arithmetic

FC-0701 = Sıfıra bölme
    .help = Böleni denetleyin; tan 90 da sıfıra bölme sayılır.
FC-0702 = Fonksiyon bu değer için tanımlı değil
    .detail = { $name }, değer { $value }
    .detail-2 = { $name }
    .help = Değeri denetleyin: kök sıfır ya da üstünü, logaritma sıfırdan büyüğünü, arksinüs ve arkkosinüs -1 ile 1 arasını ister.
FC-0703 = Böyle bir değişken yok
    .detail = { $variable }
    .help = Kontrolde bulunan bir değişken kullanın.
FC-0704 = Değişkene yazılamaz
    .detail = { $variable }
    .help = Değeri yazılabilen bir değişkene atayın.
FC-0705 = Sonuç, kontrolün sayı aralığının dışında
    .help = Hesabın başladığı değerleri denetleyin.

## Machine

FC-0801 = Bir eksen yazılım sınırlarının dışına çıkacak
    .detail = { $axis } hedefi { $position }, sınır { $limit }
    .detail-2 = { $axis }
    .help = İş sıfırını, takım boyunu ve koordinatları denetleyin; sınırlar tezgâh dosyasındadır.
FC-0802 = İş mili dururken kesme
    .help = İlk kesmeden önce iş milini M03 ya da M04 ve S devriyle çalıştırın.
FC-0803 = Takım magazinde yok
    .detail = T{ $tool }
    .help = Takımı yükleyin ya da takım numarasını düzeltin.
FC-0804 = İş mili bu devre ulaşamaz
    .detail = S{ $speed }, en çok { $limit }
    .help = Daha düşük bir devir programlayın.
FC-0805 = Tezgâh bu hareketi programlanan ilerlemeyle yapamaz
    .detail = F{ $feed }, en çok { $limit }
    .help = Daha düşük bir ilerleme programlayın; eksen hızları tezgâh dosyasındadır.
FC-0806 = Programın beklediği giriş gelmiyor
    .help = Girişi ve adresini denetleyin ya da daha uzun bekleyin.
FC-0807 = Bir eksen komut konumundan çok uzakta
    .detail = { $axis }: sapma { $distance }, sınır { $limit }
    .help = Eksenin sıkışıp sıkışmadığını, sürücüsünü ve izleme hatası sınırını denetleyin.
FC-0808 = Bir eksen durduktan sonra konuma girmiyor
    .detail = { $axis }: sapma { $distance }, sınır { $limit }
    .help = Sürücüyü, konuma girme aralığını ve süresini denetleyin.
FC-0809 = Eksen, hatve hatası telafi noktası olmayan bir yerde
    .detail = { $axis } konumu { $position }, noktalar { $limit } konumunda bitiyor
    .help = Referans konumundaki noktanın numarasını ve noktaların aralığını denetleyin.

## Files

FC-0901 = Dosya okunamıyor
    .detail = { $file }: { $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = Yolu ve dosyanın okunmasına izin olup olmadığını denetleyin.
FC-0902 = Dosya bir program metni değil
    .detail = { $file }
    .help = UTF-8 ya da GB18030 kodlu bir metin dosyası verin.
FC-0903 = Dosyada hiç blok yok
    .detail = { $file }
    .help = Doğru dosya olup olmadığını ve eksiksiz aktarılıp aktarılmadığını denetleyin.
FC-0904 = Kurulum ya da tezgâh dosyası kullanılamıyor
    .detail = { $file }: { $reason }
    .detail-2 = { $file }
    .detail-3 = { $reason }
    .help = Dosyayı nedenin gösterdiği yerde düzeltin.
FC-0905 = Kontrolün program dili bilinmiyor
    .detail = { $name }
    .help = Dili --dialect ile belirtin: gsk990mc, weihong, kaitong, fagor8065 ya da rs274.
FC-0906 = Bu sürüm kodu yürütmüyor
    .detail = { $word }
    .help = Kodu silin ya da yerine aynı işi yapan başka kodlar yazın.

FC-0907 = Bir dosyaya yazılamıyor
    .help = Yolu, boş alanı ve klasörün izinlerini denetleyin.
    .detail = { $file }: { $reason }
FC-0910 = Çıktı, komutun okuduğu bir dosya
    .help = Çıktıya başka bir ad verin. Hiçbir şey yazılmadı.
    .detail = { $file }

FC-0706 = #0 değişkeni her zaman boştur, değer alamaz
    .help = Başka bir değişken kullanın.

FC-0707 = Kontrolde bu makro işlemi yok
    .help = G65'in H kodunu denetleyin.

FC-0708 = Bu adres bir makroya argüman geçiremez
    .help = G, L, N, O, P ve H dışında harfler kullanın, her birini bir kez.

FC-0709 = Makro çağrıları çok derin iç içe
    .help = Daha az makroyu iç içe çağırın.

FC-0710 = Döngü ya da koşul yürütülemez
    .help = DO ve END için 1 ile 3 arasında bir etiket, sayan bir döngü için 0'dan farklı bir adım verin ve her döngüyü, her koşulu kapatın.

FC-0711 = Döngüler eşleşmiyor
    .help = Her DO için aynı etiketli tek bir END yazın; döngüler birbirini kesmesin.

FC-0712 = Bir atlama döngünün içine giriyor
    .help = Döngüden önceki ya da sonraki bir bloğa atlayın.

FC-0713 = Program bir alarm verdi
    .help = Nedenine programda bakın.
FC-0714 = Program ya da sıra numarası değişken olamaz
    .help = O ya da N arkasına sayının kendisini yazın.

FC-0405 = Bu kontrolde ölçekleme açık değil
    .help = 60#5 bitini 1 yapın.

FC-0406 = Ölçek çarpanı aralığının dışında
    .detail = { $min } ile { $max } arası
    .help = Kontrolün kabul ettiği bir çarpan kullanın.

FC-0407 = Ölçekleme etkinken bu koda izin yok
    .help = Önce ölçeklemeyi G50 ile iptal edin.

FC-0408 = Döndürme etkinken bu koda izin yok
    .help = Önce döndürmeyi G69 ile iptal edin.

FC-0409 = Kutupsal koordinatlarda bu koda izin yok
    .help = Önce kutupsal koordinatları G15 ile iptal edin.

FC-0410 = Döndürme etkinken düzlem değiştirilemez
    .help = Önce döndürmeyi G69 ile iptal edin.

FC-0411 = Kutupsal koordinatlarda yay R ile verilmelidir
    .help = I, J, K yerine R programlayın.

FC-0412 = Ölçekleme, döndürme ya da kutupsal koordinatlar etkinken birim değiştirilemez
    .help = Önce dönüşümü iptal edin.

FC-0413 = Ölçekleme, döndürme ya da kutupsal koordinatlar etkinken atlama işlevi çalışmaz
    .help = Önce dönüşümü iptal edin.

FC-0414 = Eksen belirtilmeden referans noktasına dönüş
    .help = Dönecek eksenleri yazın.

FC-0415 = Böyle bir referans noktası yok
    .help = Kodun aldığı bir numara kullanın: G30 ile P2, P3 ya da P4, M902 ile H0 - H3 (X, Y, Z, A).

FC-0416 = Konum, referans noktası değil
    .help = Konumu ve etkin ofsetleri denetleyin.

FC-0417 = Sabit çevrim etkinken veri yazılamaz
    .help = Önce çevrimi G80 ile iptal edin.

FC-0418 = Bu veri girişi biçimi yok
    .help = L2, L10-L13, L20, L50 ya da L51 kullanın.

FC-0419 = Ofset numarası eksik ya da çok büyük
    .help = P değerini denetleyin.

FC-0420 = Ofset değeri eksik ya da çok büyük
    .help = R değerini denetleyin.

FC-0421 = Parametrenin numarası, biti ya da değeri eksik ya da aralığının dışında
    .help = N, P ve R değerlerini denetleyin.

FC-0422 = Program bu parametreyi değiştiremez
    .help = Parametre sayfasında değiştirin.

FC-0423 = Parametre girişi sürerken başka bir komut
    .help = Önce veri girişini G11 ile bitirin.

FC-0507 = Deliğin dip düzeyi Z, R düzeyinin üstünde değil
    .help = Ters delik büyütmede R'yi alt düzey olarak verin.

FC-0508 = Kılavuz çekmede iş mili devri eksik ya da çok yüksek
    .detail = { $parameter }
    .help = Kılavuz çekme sınırı içinde bir S verin.

FC-0509 = Çevrim etkinken rijit kılavuz çekme çağrılıyor
    .help = M29'dan önce çevrimi G80 ile iptal edin.

FC-0310 = Pah ya da köşe yayı yanlış yazılmış
    .help = Bir G01, G02 ya da G03 bloğunun sonuna uzunluğuyla ,L ya da ,R yazın.

FC-0311 = Pah ya da köşe yayının arkasındaki hareket eksik
    .help = Hemen arkasına bir G01, G02 ya da G03 hareketi yazın.

FC-0312 = Pah ya da köşe yayı yanındaki hareketlerden uzun
    .help = Pahı ya da yayı küçültün ya da hareketleri uzatın.

FC-0313 = Pah ya da köşe yayının yanındaki bir hareket düzlemden çıkıyor
    .help = Yalnız düzlemin iki eksenini hareket ettirin.

FC-0424 = Yarıçap telafisi iki bloğun kesişimini bulamıyor
    .help = Daha küçük bir takım kullanın ya da bu köşede hareketleri büyütün.

FC-0425 = Yarıçap telafisi bir yayla başlıyor ya da bitiyor
    .help = Telafiyi bir G00 ya da G01 hareketinde başlatın ve iptal edin.

FC-0426 = Atlama işlevi yarıçap telafisinde çalışmaz
    .help = Önce telafiyi G40 ile iptal edin.

FC-0427 = Yarıçap telafisinde düzlem değiştirilemez
    .help = Önce telafiyi G40 ile iptal edin.

FC-0428 = Yarıçap telafisinde yayın ucu merkezine düşüyor
    .help = Daha küçük bir takım ya da daha büyük bir yay kullanın.

FC-0429 = Yarıçap telafisinde iş koordinat sistemi değiştirilemez
    .help = Önce telafiyi G40 ile iptal edin.

FC-0430 = Takım parçayı fazladan kesecek
    .help = Daha küçük bir takım kullanın ya da köşeyi veya yayı genişletin.

FC-0431 = Yarıçap telafisinde çok fazla hareketsiz blok var
    .help = Bu blokları G41'in önüne ya da G40'ın arkasına alın.

FC-0432 = Köşe çevresindeki yay yarıçap telafisinin dışında
    .help = G39'u yalnız G41 ya da G42 ile G40 arasında kullanın.

FC-0433 = Yarıçap telafisinde bir blok aynı yoldan geri gidiyor
    .help = Telafi içinde yolu tersine çevirmeyin.

FC-0213 = Aynı anda hareket edebilecek olandan fazla eksen
    .help = Hareketi bölün ya da dört eksen için 9#1 bitini 1 yapın.

FC-0214 = Takım numarasında çok fazla basamak var
    .help = T'yi denetleyin; basamak sayısını P206 belirler.

FC-0215 = Kodun gerektirdiği bir sözcük eksik
    .detail = { $word }
    .help = Sözcüğü bloğa ekleyin.

FC-0216 = Bloktaki hiçbir kod bu sözcüğü kullanmıyor
    .help = Sözcüğü silin ya da ait olduğu kodu ekleyin.

FC-0217 = Eksen sözcükleri var, eksenleri hareket ettiren kod yok
    .help = G0, G1 ya da başka bir hareket kodu ekleyin; G80 ile hiçbir eksen hareket etmez.

FC-0218 = Kod, eksen sözcükleri ister
    .help = En az bir eksen yazın.

FC-0219 = Bu kodlar aynı blokta olamaz
    .help = Kodları ayrı bloklara yazın. G53 yalnız G90'da G0 ve G1 ile kullanılır; eksen sözcüklerini kullanan kodlardan bir blokta yalnız biri bulunur.

FC-0220 = Sınırlar kaldırılmaz
    .help = Kodun etkisi yoktur: hiçbir eksen strokunun dışına çıkmaz. Yazılım sınırları eksenler referansa gittikten sonra geçerlidir; referansa giderken kaldırılacak bir şey yoktur.

FC-0221 = Ayarlanacak enkoder mandalı yok
    .help = Kodun etkisi yoktur. Referansa gidiş işaretleri kendisi bulur; bir girişin bitirdiği hareketten sonra kontrol, eksenlerin nerede durduğunu bilir.

FC-0314 = Devir başına ilerleme, enkoderli bir iş mili ister
    .help = G94 kullanın ya da enkoder takın.

FC-0315 = Ölçekleme koordinatı çok büyütüyor
    .help = Daha küçük bir çarpan kullanın.
FC-0316 = Yay, düzleminin dışındaki bir ekseni hareket ettiriyor
    .detail = { $axis }
    .help = Ekseni ayrı bir blokta hareket ettirin ya da yayın bulunduğu düzlemi seçin.
FC-0317 = Helis dönmeden ilerliyor
    .help = Yaya düzlemde bir bitiş noktası verin ya da merkeziyle tam daire programlayın; doğrusal hareket için G01 kullanın.

FC-0318 = Tezgâh koordinatlarında bir yay
    .help = G53'ün bloğunda G00 ya da G01 programlayın.

FC-0434 = Ofset değeri çok büyük
    .help = Değeri ofset tablosunda düzeltin.

FC-0435 = Ara nokta çok uzakta
    .help = Bloğun koordinatlarını denetleyin.

FC-0436 = Ölçekleme, döndürme ya da kutupsal koordinatlar etkinken / işaretli bir blok
    .help = Bloktan önce dönüşümü iptal edin.

FC-0437 = Ölçekleme, döndürme ya da kutupsal koordinatlar etkinken bir ofset değişiyor
    .help = Önce dönüşümü iptal edin.

FC-0438 = G12 ayrı bir blok ister
    .help = Diğer kodları başka bir bloğa taşıyın.

FC-0439 = Strok denetiminin köşeleri bir alan oluşturmuyor
    .help = X, Y, Z değerleri I, J, K değerlerinden büyük olmalıdır.

FC-0440 = Hareket, kayıtlı strok denetiminin yasakladığı alana giriyor
    .help = Hareketi değiştirin ya da denetimi G13 ile kapatın.

FC-0441 = Sabit kesme hızı için böyle bir eksen yok
    .help = Tezgâhın bir ekseni için P1 ile P4 arasını kullanın.

FC-0442 = Boy telafisi, buna izin vermeyen bir kodun bloğunda
    .detail = { $word }
    .help = Boy telafisini ayrı bir bloğa yazın.

FC-0453 = Takım boyu değişmiyor: bir çevrim etkin
    .help = Takım boyu değişmeden önce çevrimi G80 ile bitirin ya da boyu çevrimi başlatan blokta programlayın.

FC-0443 = Yarıçap telafisi etkinken ölçekleme kuruluyor
    .help = Ölçeklemeyi G41 ya da G42'den önce programlayın ya da önce telafiyi G40 ile iptal edin.

FC-0444 = Ölçekleme eksik ya da iki tür çarpan birlikte verilmiş
    .help = Eksenlerin merkezini P ile birlikte ya da her eksen için I, J, K verin.

FC-0445 = Aynalamada eksen belirtilmemiş
    .help = Her eksenin aynalanacağı koordinatı verin.

FC-0446 = Aynı anda çok fazla dönüşüm etkin
    .help = Her döndürmeyi bir sonrakinden önce G69 ile iptal edin; yinelenen alt programlarda da.
FC-0447 = Atlama hareketi, sinyali gelmeden bitti
    .help = Probu, kablosunu ve hareketin yeterince uzun olduğunu denetleyin; bunun alarm olup olmadığını P021.3 belirler.
FC-0451 = Probun sinyali hareket başlamadan önce var
    .help = Ölçmeden önce parçadan uzaklaşın, G38.4 için parçaya değdirin; probu ve kablosunu denetleyin. G38.3 ve G38.5 buna izin verir.

FC-0452 = G29'un geçeceği bir ara nokta yok
    .detail = { $axis }
    .help = G29'dan önce bu eksenle G28 ya da G30 programlayın veya noktaya G00 ile gidin.

FC-0510 = İlerlemesi olmayan rijit kılavuz çekme
    .help = F'yi çevrimde ya da öncesinde verin.

FC-0511 = M29 ile kılavuz çekme çevrimi arasında bir devir ya da hareket var
    .help = S'yi M29'un bloğunda verin, eksenleri ondan önce hareket ettirin.

FC-0512 = Rijit kılavuz çekmede düzlem değişiyor
    .help = Önce rijit kılavuz çekmeyi G80 ya da M28 ile bitirin.

FC-0513 = Çevrim, bir açıda durabilen iş mili ister
    .help = Başka bir çevrim kullanın ya da böyle bir iş mili takın.

FC-0610 = Bir makro, alt program çağırıyor
    .help = Bunun yerine G65 ile bir makro çağırın.

FC-0611 = M99, makro çağrısının bloğunda
    .help = M99'u ayrı bir bloğa yazın.

FC-0612 = Program numarası çok büyük
    .help = O0 ile O99999 arasını kullanın.
FC-0613 = Atlanacak sıra numarası yok
    .detail = { $number }
    .help = Atlanacak bloğa bu sıra numarasını verin; blok aynı programda olmalıdır.

FC-0908 = Resim dosyası .png ya da .svg olmalı
    .help = Çıktı dosyasına bu uzantılardan birini verin.
    .detail = { $file }

FC-0909 = Grafiğin ayarı kullanılamıyor
    .help = Tezgâhın eksenlerini harfleriyle yazın; başlangıç programın bitişinden önce, bitiş başlangıçtan sonra olsun ve dosya .svg olsun.
    .detail = { $setting }: { $value }; izin verilen: { $allowed }

FC-0514 = Bir eksen aynalanmışken frezeleme çevrimi çağrılıyor
    .help = Artı ölçek çarpanları kullanın.

FC-0515 = Adım ya da başlangıç uzaklığı çok küçük
    .help = Daha büyük bir L kullanın.

FC-0516 = Adım ya da başlangıç uzaklığı çok büyük
    .help = Daha küçük bir L kullanın.

FC-0517 = Takım ya da helisi sığmıyor
    .help = Daha küçük bir takım ya da daha küçük bir helis çarpanı P269 kullanın.

FC-0518 = Köşe yarıçapı, bir kenarın yarısından büyük
    .help = Daha küçük bir köşe yarıçapı kullanın.

FC-0519 = Köşe yarıçapı takım yarıçapından küçük
    .help = Daha büyük bir U ya da daha küçük bir takım kullanın.

FC-0520 = Kesilmemiş malzeme üzerindeki boşluk eksik
    .help = 0'dan büyük bir V verin.

FC-0521 = İlk paso derinliği eksik
    .help = 0'dan büyük bir W verin.

FC-0522 = Paso derinliği eksik
    .help = 0'dan büyük bir Q verin.

FC-0523 = Yarıçap ya da ilk boyut eksik
    .help = I'yı verin.

FC-0524 = İkinci boyut ya da başlangıç uzaklığı eksik
    .help = J'yi verin.

FC-0525 = Takım yarıçapı eksik
    .detail = { $parameter }
    .help = D'yi verin ve ofset tablosunda takıma bir yarıçap girin.

FC-0526 = Çevrim çok fazla hareket gerektirir
    .detail = { $parameter }
    .help = Daha büyük bir adım ya da paso derinliği kullanın.
FC-0527 = İş mili devri olmayan rijit kılavuz çekme
    .help = S programlayın; en iyisi kılavuz çekmeyi rijit yapan kodun bloğunda.

FC-0528 = Diş adımı hiç verilmemiş kılavuz çekme çevrimi
    .help = Çevrimle birlikte diş adımı F'yi ya da inçteki diş sayısı I'yı programlayın.

FC-0529 = Diş adımı iki kez verilmiş
    .detail = { $word }
    .help = F ya da I programlayın, ikisini birden değil.
FC-0530 = Sabit çevrim olmadan bir şekil üzerinde delikler
    .help = Sabit çevrimi şekilden önce programlayın; G34 - G37'den önce, kendisi delik açmasın diye K0 ile.
FC-0531 = Z ölçeklenmişken sabit çevrim
    .help = Ölçeklemeyi G50 ile iptal edin ya da Z'yi dışında bırakın.
FC-0532 = X ve Y farklı ölçeklenirken frezeleme çevrimi çağrılıyor
    .help = X ve Y için aynı çarpanı verin ya da ölçeklemeyi G50 ile iptal edin.

FC-0533 = Kılavuz çekme ilerlemesi en yüksek kesme ilerlemesinin üstünde
    .detail = F{ $feed }, en çok { $limit }: iş mili { $speed } ile döner
    .detail-2 = F{ $feed }, en çok { $limit }
    .help = F ile S'yi birlikte düşürün. Rijit kılavuz çekmede diş adımı korunur: iş mili ilerlemeyle birlikte yavaşlar. Yüzer tutucuda yalnız ilerleme düşer ve diş bozulur.
FC-0534 = Çevrimin en kısa beklemesi en uzunundan küçük değil
    .help = En kısa bekleme parametresini en uzununkinin altına ayarlayın.
FC-0535 = Çevrim delik açmıyor: R seviyesi veya Z derinliği eksik
    .help = R ve Z programlayın. Biri eksikse takım yalnızca yerlerin üzerine konumlanır.
FC-0536 = Takım delikte yana çekilmiyor: Q eksik
    .help = Q ile ne kadar yana çekileceğini programlayın. Yoksa kesici kenar delikte iz bırakır, geri delik büyütmede takım deliğe tüm genişliğiyle girer.
FC-0537 = Çevrim, bloğundaki başka bir kodun yanında delik açmıyor
    .detail = { $word }
    .help = Çevrimi, o kodun ardından, ayrı bir blokta programlayın.

## Canned cycles by parameters

FC-0540 = Çevrimin bir parametresi alamayacağı bir değerde
    .detail = { $parameter } değeri { $value }, sınır { $limit }
    .detail-2 = { $parameter }
    .help = Parametreyi değiştirin; alabileceği değerler `explain` komutunda ve kılavuzun bu çevrimle ilgili sayfasındadır.
FC-0541 = Çevrimin gerektirdiği bir parametre eksik
    .detail = { $parameter }
    .help = Parametreyi çevrim kodunun arkasına programlayın.
FC-0542 = Çevrimin kesecek derinliği yok
    .detail = { $parameter }
    .help = Dibe yüzeyden farklı bir düzey verin; tabanda bırakılan paydan sonra kaba işlenecek bir şey kalmalıdır.
FC-0543 = Takım, keseceği yer için çok büyük
    .detail = { $parameter }: yarıçap { $value }, en çok { $limit }
    .detail-2 = { $parameter }
    .help = Daha küçük bir takım alın, cebi ya da deliği genişletin ya da duvarda daha az pay bırakın. Takım tablosundaki yarıçapı denetleyin.
FC-0544 = Takım o kadar küçük ki delikte göbek kalır
    .detail = { $parameter }: yarıçap { $value }, en az { $limit }
    .detail-2 = { $parameter }
    .help = Daha büyük bir takım alın ya da önce deliği delip çapını verin.
FC-0545 = Pasolar takımdan geniş
    .detail = { $parameter } değeri { $value }, çap { $limit }
    .detail-2 = { $parameter }
    .help = En çok takım çapı kadar bir genişlik ya da çapın dörtte üçü için 0 programlayın.
FC-0546 = Adım 0 kesici boy demektir, ama takım tablosunda kesici boy yok
    .detail = { $parameter }
    .help = Adımı programlayın ya da takımın kesici boyunu girin.
FC-0547 = Duvar paso sayısı 0 ve bir pasonun ne kadar derin olabileceği belli değil
    .detail = { $parameter }
    .help = Paso sayısını programlayın, ince işleme takımının kesici boyunu girin ya da ince işlemeyi kaba işleme takımıyla yapın.
FC-0548 = Takım malzemeye bu açıyla giremez
    .detail = { $parameter }
    .help = 0 ile 90 derece arasında bir açı programlayın. Açılı inmek için yer yoksa daha küçük bir takım alın ya da dik dalabilen takım için 90 programlayın.
FC-0549 = Çevrimin ilerlemesi yok
    .detail = { $parameter }
    .help = Çevrimin ya da aşamanın ilerlemesini programlayın.
FC-0550 = İşlem sayısı tam sayı değil
    .detail = { $parameter }
    .help = Tam bir sayı ya da uzunluğu tam bölen bir uzaklık programlayın.
FC-0551 = Atlanacak noktalar artan sırada değil
    .detail = { $parameter }
    .help = Noktaları harf sırasıyla ilkinden sonuncusuna programlayın. Bir aralığın son noktası üç basamaklıdır: 10.013, 10 ile 13 arası demektir.
FC-0552 = Konumları belirleyen parametreler çok az ya da birbiriyle çelişiyor
    .detail = { $parameter }
    .help = Biçimlerden birinin parametrelerini programlayın: örneğin uzunluk ve sayı ya da uzaklık ve sayı.
FC-0553 = Bir çevrim parametresi var, bu parametreyi taşıyan çevrim yok
    .detail = { $variable }
    .help = Çevrim değişkenlerini çevrim etkinken ve biçimindeki harflerle kullanın.
FC-0554 = Kontrolde bu yönerge yok
    .detail = { $word }
    .help = # işaretinin arkasındaki adı denetleyin; tanımladığı çevrimler G281 ile G299 arası, P2D ve P3D'dir.
FC-0555 = Çevrimde bu parametre yok
    .detail = { $parameter }
    .help = Adı denetleyin; büyük ve küçük harf ayrıdır, Yunan harfleri sözcük olarak yazılır.
FC-0556 = Parametre bu değeri almıyor
    .detail = { $parameter }
    .help = Sayı istenen yere sayı, sözcük istenen yere sözcüklerinden birini, nokta için [x,y] yazın.
FC-0557 = Çevrimin bir bölümü yanlış yerde
    .detail = { $word }
    .help = Bölümü #CYCLE bloğunun hemen arkasına, bir kez ve yalnız çevrimde böyle bir bölüm varsa yazın.
FC-0558 = Profil yok
    .detail = { $parameter }
    .help = Profili, onu kullanan çevrimden önce #PROFILE ile tanımlayın.
FC-0559 = Profil okunamıyor
    .detail = { $parameter }, kontur { $contour }
    .detail-2 = { $parameter }
    .help = Profil G0 ile başlar, G1, G2, G3 ve köşe kodları G36 ve G39 ile sürer, #ENDPROFILE ile biter.
FC-0560 = Profil açık
    .detail = { $parameter }, kontur { $contour }
    .detail-2 = { $parameter }
    .help = Cebin her konturu başladığı yerde bitmelidir.
FC-0561 = Profil kendini kesiyor ya da konturlar birbirini kesiyor
    .detail = { $parameter }, kontur { $contour }
    .detail-2 = { $parameter }
    .help = Konturları düzeltin; adalar dış konturun içinde kalmalı, ona ve birbirine değmemelidir.
FC-0562 = Profildeki yuvarlatma ya da pah için yer yok
    .detail = { $parameter }
    .help = Yuvarlatmayı ya da pahı küçültün veya yanındaki öğeleri uzatın; bunlar iki öğenin arasında bulunur.
FC-0563 = Profile teğetsel giriş ya da çıkış için yer yok
    .detail = { $parameter }
    .help = Daha küçük bir yarıçap ya da daha uzak bir giriş veya çıkış noktası programlayın; 0 düz yoldur.
FC-0564 = Düzlem bu eksenlerden oluşamaz
    .detail = { $axis }
    .help = Üç farklı eksen yazın. Yaylar ve frezeleme çevrimleri X, Y ve Z düzlemlerini, takımı da üçüncü eksen boyunca ister.
FC-0565 = Cebin bir konturunun alanı yok
    .detail = { $parameter }, kontur { $contour }
    .detail-2 = { $parameter }
    .help = Kontura bir alanı çevreleyen öğeler verin; kendi üzerinden geri dönen konturun alanı olmaz.
FC-0566 = Bir ada cebin içinde değil
    .detail = { $parameter }, kontur { $contour }
    .detail-2 = { $parameter }
    .help = Önce dış konturu, sonra bütünüyle onun içinde kalan adaları tanımlayın.
FC-0567 = Derinlik profili konturuna uymuyor
    .detail = { $parameter }
    .help = Konturunun başladığı yerde başlatın: dış konturda yüzeyde, adada tabanda; geri dönmeden sürsün.
FC-0568 = Eğik duvarlar, cep istenen derinliğe varmadan birleşiyor
    .detail = { $parameter }
    .help = Bu derinlik profilinin duvarlarını dikleştirin, cebi sığlaştırın ya da konturların arasını açın.
FC-0569 = Bu duvarların yanında yeterince doğru bir yol hesaplanamıyor
    .detail = { $parameter }
    .help = Profilden takımdan çok küçük olan öğeleri çıkarın ya da başka bir takım yarıçapı veya ince işleme payı alın.
FC-0575 = Takım dolu malzemeye dik dalıyor
    .detail = { $parameter }
    .help = Bir giriş açısı programlayın, takıma giriş açısı girin ya da cebi önceden delin. Merkezden kesen takım bunlarsız da dalabilir.

FC-0470 = Yarıçap telafisinin giriş hareketi takım yarıçapından uzun değil
    .help = Konturdan daha uzakta başlayın: giriş, yarıçaptan uzun olmalıdır.
FC-0471 = Takım yayın içine sığmıyor
    .help = Yarıçapı yayınkinden küçük bir takım kullanın.
FC-0472 = Yarıçap telafisinden sonraki ilk hareket bir yay
    .help = Konturdan bir G00 ya da G01 hareketiyle çıkın.

FC-0319 = İş mili devri 0 iken devir başına ilerleme
    .help = Hareketten önce S verin ya da G94 kullanın.

FC-0320 = Pah ya da köşe yayından sonraki hareket düzlemden çıkıyor
    .help = Orada yalnız düzlemin iki eksenini hareket ettirin.

FC-0321 = Yarıçap telafisinde bir yay kendi merkezinde başlıyor
    .help = I, J ve K değerlerini denetleyin: bunlar yayın başından merkezine olan uzaklıklardır.

FC-0322 = Yay başladığı yerde bitiyor: hareket yok
    .help = Yarıçap tam daire vermez. Merkezini I, J veya K ile programlayın ya da bitiş noktasını denetleyin.

FC-0448 = Yarıçap telafisinde takım değişimi
    .help = Önce telafiyi G40 ile bitirin.

FC-0449 = Yarıçap telafisinde koordinat sistemleri kaydırılamaz
    .help = Önce telafiyi G40 ile bitirin.

FC-0450 = Yarıçap telafisinde referans noktasına dönüş
    .help = Önce telafiyi G40 ile bitirin.

FC-0614 = Etiket daha önce verilmiş
    .help = Her döngüye, koşula ve alt programa kendi etiketini verin. Tanımından önce çağrılmış bir alt programa program akışı yukarıdan giremez: tanımları M2'nin arkasına ya da çağrıların önüne alın.

FC-0615 = Burada bu etiketle açık bir döngü ya da koşul yok
    .help = Etiketi denetleyin. break ve continue yalnız while ve do döngülerinin geçişlerini bitirir.

FC-0616 = Alt program dışında bir return
    .help = Alt program sub ile başlar, call ile çalıştırılır.

FC-0617 = Bir alt program başka birinin içinde tanımlanıyor
    .help = İkincisinden önce ilk tanımı endsub ile bitirin.

FC-0618 = Program öbür türün yöntemiyle çağrılıyor
    .help = sub ile başlayan call ile, yalnız O numarasıyla başlayan M98 ile çalıştırılır.

FC-0619 = Çok fazla etiket var
    .help = Programa sınırsız sayıda etiket hesaplatmayın.

FC-0620 = Geri yüklenecek kayıtlı durum yok
    .help = Önce aynı alt programda M70 ya da M73 ile saklayın.

FC-0621 = Programlar burada dosya yazmaz
    .help = Açıklamayı silin ya da metni print veya MSG ile gösterin.
FC-0330 = U, V ve W düzlemlerinde yay yoktur
    .help = G17, G18 ya da G19 seçin.
FC-0331 = Yayın hem yarıçapı hem merkezi var
    .help = R'yi ya da merkezi I, J ve K'den ikisiyle verin.
FC-0332 = Bir merkez sözcüğü düzleme ait değil
    .help = I X'e, J Y'ye, K Z'ye aittir; yalnız düzlemin eksenlerininkiler bulunabilir.
FC-0333 = Yarıçapla verilen yay başladığı yerde bitiyor
    .help = Bunun yerine merkezi verin: yarıçap, tam dairenin nerede olduğunu söylemez.
FC-0334 = Spline eğrileri XY düzleminde olur
    .help = G17 seçin.
FC-0335 = Spline boyunca yalnız X ve Y hareket eder
    .help = Öbür eksenleri ayrı bir blokta hareket ettirin.
FC-0336 = Spline'ın kontrol noktası çok az
    .detail = { $number } kontrol noktası, en az { $least } gerekir
    .help = Kontrol noktası ekleyin ya da L ile daha düşük bir mertebe verin.
FC-0337 = Başlatılmamış bir NURBS bitiriliyor
    .help = Önce kontrol noktalarını, araya başka bir hareket kodu koymadan G5.2 ile tanımlayın.
FC-0338 = Spline çok uzun
    .detail = sınır { $limit } nokta
    .help = Birkaç eğriye bölün.
FC-0339 = Prob hareketinin uzunluğu yok
    .help = Dokunulacak noktadan daha uzakta başlayın.
FC-0473 = Yarıçap telafisi bu düzlemde çalışmıyor
    .help = G17 ya da G18 seçin.
FC-0474 = Yarıçap telafisi zaten açık
    .help = Önce G40 ile iptal edin.
FC-0475 = Yarıçap telafisinde bu koda izin yok
    .help = Önce telafiyi G40 ile iptal edin.
FC-0476 = Torna takımıyla yarıçap telafisi
    .help = Uç yönü 0 ya da 9 olan bir takım kullanın; öbürleri henüz telafi edilmiyor.
FC-0477 = Y döner eksendir: düzleminde yay, döndürme, yarıçap telafisi ya da delik düzeni olamaz
    .help = Y'siz bir düzlem seçin ya da biçimi doğrusal hareketlerle yazın.
FC-0570 = Bu eksen çevrimde hareket etmez
    .detail = { $axis }
    .help = Düzlemin eksenlerini ve ona dik olanı yazın; öbürlerini ayrı bir blokta hareket ettirin.
FC-0571 = Sabit çevrim başka bir ilerleme birimi ister
    .help = G94 ya da G95 seçin; G93 her hareketine bir süre verirdi.
FC-0572 = İş mili dönmüyor
    .help = Bu bloktan önce M3 ya da M4 ile çalıştırın.
FC-0573 = İş mili bu diş için ters yönde dönüyor
    .help = Sağ dişleri M3, sol dişleri M4 ile çekin.
FC-0574 = Dişin derinlikleri birbirine uymuyor
    .help = I 0 olmamalı, J 0'dan, K da J'den büyük olmalıdır.
FC-0622 = Bu dilde M6'da takımı değiştiren yok
    .help = Takımı merdiven programının kendisi ya da siz elle değiştiriyorsanız makine dosyasındaki [tool_change] bölümünde program = 0 yapın. İş milinde hâlâ eski takım var.
FC-0623 = Dosyadaki iki programın numarası ya da adı aynı
    .detail = { $program }
    .help = Her programa ayrı bir numara verin: çağrı bunlardan ilkini çalıştırır.

# The running control.

FC-1400 = bu modda yapılamaz
    .help = Önce uygun modu seçin.
    .detail = mod { $mode }
FC-1401 = program çalışırken yapılamaz
    .help = Bitmesini bekleyin ya da reset ile sonlandırın.
FC-1402 = başka bir modun programı sürüyor
    .help = Sürdürmek için o moda dönün ya da reset ile sonlandırın.
    .detail = mod { $mode }
FC-1403 = çalıştırılacak program yok
    .help = Program seçin ya da MDI'da blok yazın.
FC-1404 = tezgâh şu anda başlatmaya izin vermiyor
    .help = Tezgâhın iletilerine bakın: kapı açık, basınç yok ya da bağlama sıkılmamış olabilir.
FC-1405 = bir alarm var
    .help = Nedenini giderin, sonra reset tuşuna basın.
FC-1406 = bu kontrolde bunun için gereken parça yok
    .help = Merdiven programı ya da kalıcı bellek olmadan başlatıldı.
    .detail = eksik: { $name }
FC-1407 = bu adda bir şey yok
    .help = Yazımını denetleyin.
    .detail = { $name }
FC-1408 = çalışan program değiştirilemez
    .help = Bitmesini bekleyin ya da başka bir programı düzenleyin.
    .detail = program { $name }
FC-1409 = bu değer olamaz
    .help = Aralık içinde bir değer girin.
    .detail = { $name }: { $min } ile { $max } arası
    .detail-2 = { $name }
FC-1410 = acil durdurma
    .help = Tehlikeyi giderin, düğmeyi bırakın ve eksenleri yeniden referansa gönderin.
FC-1411 = programda böyle bir blok yok
    .help = Programın bir satırını seçin.
    .detail = satır { $line }
FC-1412 = merdiven programı duruyor
    .help = Programı düzeltip yeniden başlatın; o zamana kadar bütün çıkışlar kapalıdır.
FC-1413 = değişiklik yapıldı ama saklanamadı
    .help = Diske bakın; güç kesilince değişiklik yok olur.
    .detail = { $reason }
FC-1414 = Referansa gitmemiş eksenlerle program sürdürülemez
    .detail = eksen { $axis }
    .help = Eksenleri referansa gönderin, sonra sürdürmeyi yeniden hazırlayın.
FC-1415 = Yarıda kalan program, seçili olan değil
    .detail = yarıda kalan: { $name }
    .help = Yarıda kalan programı seçin ya da bu programın bir satırını verin.
FC-1416 = Program ya da veriler artık eskisi gibi değil
    .detail = { $name }
    .help = Sürdürmeyi yeniden hazırlayın; program değiştiyse satırı verin.
FC-1417 = Takım ya da iş mili programdaki gibi değil
    .detail = { $name }
    .help = Sürdürmenin gösterdiği kodları MDI'da yazın ya da kontrole göndertin. Durmuş program, iş mili gösterildiği gibi dönünce sürer: iş milini elle çalışma modunda tuşuyla çalıştırın.
FC-1418 = programın devamı için henüz yer yok
    .help = Bloklar bittikçe bu parçayı yeniden gönderin.
FC-1419 = parametre anahtarı kapalı
    .help = MDI modunda, ayar sayfasında parametre anahtarını açın.
FC-1427 = program anahtarı kapalı
    .help = MDI modunda, ayar sayfasında program anahtarını açın. 4. seviye gerekir.
FC-1428 = bu sinyal ayarlanamaz
    .help = Merdiven programının verileri ayarlanabilir: K, T, C ve D. Öteki sinyaller zorlanır.
    .detail = { $name }
FC-1429 = eksenler şu anda yol boyunca geri gidemez
    .help = Program ilerleme durdurma ile tutulurken ve eksenler yolunun üzerinde dururken geri gidilir: diş içinde, beklemede, referansa giderken ya da hareket kilidi varken olmaz. Önce ilerleme durdurmaya basın.

FC-1430 = Referansa giderken referans anahtarı bulunamadı
    .detail = eksen { $axis }
    .help = Referans anahtarını, seviyesini ve referansa gitme yönünü denetleyin.
FC-1431 = Referansa giderken enkoderin referans işareti bulunamadı
    .detail = eksen { $axis }
    .help = Enkoderin referans işareti sinyalini ve tezgâhın referansa giderken bunu kullanıp kullanmadığını denetleyin.
FC-1432 = Referansa giderken acil durdurma
    .detail = eksen { $axis }
    .help = Acil durdurmayı bırakın ve ekseni yeniden referansa gönderin.
FC-1433 = Program, referansa gitmemiş bir ekseni hareket ettiriyor
    .detail = eksen { $axis }
    .help = Ekseni referansa gönderin, sonra programı yeniden başlatın.
FC-1434 = Kod, referansa gitmiş bir eksen ister
    .detail = eksen { $axis }
    .help = Ekseni referansa gönderin, sonra programı yeniden başlatın.
FC-1435 = Programlar bir ekseni referansa gönderemez
    .detail = eksen { $axis }
    .help = Ekseni elle referansa gönderin.
FC-1436 = Bir eksen sınır anahtarının üzerinde
    .detail = { $axis }{ $side }
    .help = Sınır bırakma tuşunu basılı tutun ve ekseni elle geri çekin.

## 1460: over a connection

FC-1460 = Bu, burada olmayan program satırlarına götürüyor
    .help = Satır satır gönderilen program yalnız ileri gider. Önce programı saklayın ya da saklanmış birini çağırın.
FC-1461 = Oraya bağlanılamaz
    .detail = { $place }: { $reason }
    .help = Başka bir port ya da yol seçin ya da onu kullananı kapatın.
FC-1440 = Bu satırda ve altında blok yok
    .detail = satır { $line }
    .help = Programda bir bloğun başladığı satırı verin.

FC-1441 = Program bloğa istenen sayıda ulaşmıyor
    .detail = satır { $line }, ulaşma sayısı { $passes }
    .help = Daha küçük bir geçiş sayısı ya da şimdiki değişken, giriş ve anahtarlarla çalışan bir satır verin.

FC-1442 = Sürdürme yolundaki eksen sırası yanlış
    .help = Tezgâhın her eksenini tam bir kez yazın.

FC-1443 = Yarıda kalmış bir şey yok
    .help = Programın sürdürüleceği satırı verin.

FC-1444 = Eksenler hareket ederken program sürdürülemez
    .help = Reset tuşuna basın ve eksenlerin durmasını bekleyin.

FC-1445 = Tezgâhın ilk çalışmada programa bildirdiği değerler bilinmiyor
    .detail = { $count } yer; tezgâh konumunun yerine komut konumu alınır
    .help = Programın bu satırdan önce ne ölçtüğünü denetleyin ya da ölçmenin öncesinden başlayın.

## 1446: tezgâh iletileri

FC-1446 = Tezgâhın iletisi
    .detail = { $name }
    .help = Tezgâhın ladder programından gelir: anlamı alarm sayfasında ve tezgâhın kılavuzunda yazar. Nedeni ortadan kalkınca gider.

FC-1447 = Bir sonraki açılışta geçerli olacak bir parametre değişti
    .help = O zamana kadar kontrol eskisi gibi çalışır. Kontrolü kapatıp yeniden açın ya da parametreyi eski değerine getirin.

## 1470: measuring

FC-1470 = Prob ya da takım ölçücü yok
    .detail = { $name }
    .help = SKIP girişine bağlayın ve parametrelerde belirtin.
FC-1471 = Prob boşta olması gereken yerde dokunuyor
    .help = Probu uzaklaştırın, yolunu ve sinyalini denetleyin, sonra ölçmeye yeniden başlayın.
FC-1472 = Prob hiçbir şeye dokunmadı
    .detail = { $axis }, { $position } konumuna kadar
    .help = Anma ölçüsünü, merkezi ve yüksekliği denetleyin; parça orada olabilirse ölçme aşımını artırın.
FC-1473 = Bu noktalar bir biçim vermiyor
    .detail = { $name }
    .help = Noktaları yeniden alın: daire için bir doğru üzerinde olmayan üç, kanal için her eksende iki nokta.
FC-1474 = Eksenler referansa gitmemiş
    .detail = eksen { $axis }
    .help = Ölçmeden önce eksenleri referansa gönderin.
FC-1475 = Ölçülen boyut toleransın dışında
    .detail = { $value }, anma ölçüsü { $nominal }, tolerans { $limit }
    .help = Hiçbir şey saklanmadı. Parçayı ya da takımı denetleyip yeniden ölçün.
FC-1476 = Böyle bir değerle ölçülemez
    .detail = { $name }
    .help = Bu biçimin istediği bütün boyut ve açıları girin.
FC-1477 = Şu anda ölçülemez
    .detail = { $name }
    .help = Boş çalışmayı ve kilitleri devre dışı bırakın, iş milini durdurun, sonra yeniden başlayın.
FC-1478 = Takım ölçücüye dokunulmadı
    .detail = { $axis }, { $position } konumuna kadar
    .help = Takım ölçücüyü, yüksekliğini ve tahmini takım boyunu denetleyin.

## 1480: drives

FC-1480 = Sürücüler yanıt vermiyor
    .detail = { $place }
    .help = Kartın beslemesini ve kablosunu, tezgâh dosyasındaki bağlantıyı denetleyin.
FC-1481 = Sürücülerden artık ses yok
    .detail = { $time } ms boyunca
    .help = Kartın kablosunu ve beslemesini denetleyin. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1482 = Sürücülerle bağlantı koptu
    .detail = { $place }: { $reason }
    .help = Kartın kablosunu ve portunu denetleyin. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1483 = Sürücüler tezgâh dosyasının istediğini yapamaz
    .detail = { $name }: istenen { $value }, mümkün olan { $limit }
    .help = Tezgâh dosyasındaki değeri değiştirin ya da başka bir kart kullanın.
FC-1484 = Bir eksenden adımlanabileceğinden hızlı gitmesi isteniyor
    .detail = eksen { $axis }: gereken { $value } adım/s, mümkün olan { $limit }
    .help = Tezgâh dosyasında eksenin hızlarını, adımlarını ya da darbe sürelerini düşürün.
FC-1485 = Sürücüler hiçbir şey duymadıkları için durdu
    .detail = { $time } ms boyunca
    .help = Kabloyu ve bilgisayarın yükünü denetleyin. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1486 = Bir konum komutu sürücülere çok geç geldi
    .help = Kontrolün iş parçacığına öncelik verin ya da arabelleği uzatın. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1487 = Bir konum komutu sürücülere giderken kayboldu
    .detail = { $count } okunamayan çerçeve
    .help = Kabloyu, ekranlamasını ve uzunluğunu denetleyin. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1488 = Bir konum komutu sürücülerin izleyebileceğinden hızlıydı
    .detail = eksen { $axis }
    .help = Eksenin hızlarını ve telafisini denetleyin. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1489 = Sürücüleri acil durdurma durdurdu
    .help = Tehlikeyi giderin ve düğmeyi bırakın. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1490 = Bir eksenin sürücüsü arıza bildiriyor
    .detail = eksen { $axis }
    .help = Sürücünün göstergesini ve kılavuzunu okuyun. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1491 = Sürücüler durdu
    .detail = kod { $code }
    .help = Kodu kartın kılavuzunda arayın. Reset tuşuna basın ve eksenleri yeniden referansa gönderin.
FC-1492 = Bu tezgâhın iş mili açısına göre yönetilemez
    .help = Dengeleyicili tutucuyla kılavuz çekin. Yönlendirme için bunu iş mili sürücüsünden isteyen bir merdiven programı gerekir.
FC-1493 = Grbl göndericileri yalnız benzetilmiş bir tezgâhı sürer
    .help = Tezgâhı --grbl olmadan sunun ya da [drives] içermeyen bir tezgâh dosyası kullanın.
FC-1494 = makine kilidi açık
    .help = Önce makine kilidini kapatın: kilitliyken eksenler göründükleri yerde değildir.
FC-1495 = bloklar önceki değerle okunmuştu
    .detail = { $line }. satıra kadar
    .help = Önceki değerle çalışırlar. Yeni değerle çalışmaları için değeri program M00'da dururken veya başlatmadan önce girin.

# The panel in a browser
FC-1500 = Panel derlenmemiş
    .help = Paneli hmi klasöründe "npm ci" ve "npm run build" ile, ardından Ferrocut'u yeniden derleyin. Kontrol yine de çalışır.

FC-1501 = Program sonuna kadar denetlenmedi
    .detail = { $line }. satırdan sonrası
    .help = Çok fazla hatası var ya da denetim çok uzun sürüyor. Bulunanları düzeltip yeniden denetleyin; "ferrocut check" komutunda sınır yoktur.

FC-1502 = Panel başka bilgisayarlara yalnız şifreli bağlantıyla sunulur
    .detail = { $place }
    .help = --tls-cert ve --tls-key ya da --tls-self-signed verin. Ya da bu bilgisayarda (127.0.0.1) bırakıp tünelle bağlanın.

FC-1503 = Panel başka bilgisayarlara yalnız oturum açılabiliyorsa sunulur
    .detail = { $place }
    .help = Bellek klasörünü --memory ile verin ve içinde "ferrocut memory password" ile bir parola belirleyin.

FC-1504 = Bu sertifika ya da anahtar kullanılamıyor
    .detail = { $file }: { $reason }
    .help = Sertifika zincirini ve özel anahtarını PEM dosyaları olarak ya da --tls-self-signed verin.

FC-1505 = Hiçbir şey saklanmıyor: iş bitince programlar, ofsetler ve parametreler kaybolur
    .help = Saklanacakları klasörü belirtin: --memory /var/lib/ferrocut. Boş ya da henüz olmayan bir klasör yeni bir bellek olur.
